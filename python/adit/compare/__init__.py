"""Runs side by side, and a run beside the reference of its case."""
