"""Runs on several machines: jobs of Slurm, and the certificates by which machines trust each other."""
