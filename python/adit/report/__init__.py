"""The report of a run: one page that is readable without network."""
