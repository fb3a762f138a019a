"""The page docs/trade.md: a template that a person writes, filled with results."""
