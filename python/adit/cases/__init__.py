"""Measurements in the runs of the cases' studies, and the theory for comparison."""
