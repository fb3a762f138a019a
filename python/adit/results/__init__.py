"""The files of a run, read at first use."""
