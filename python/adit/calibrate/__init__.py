"""Micro-properties of bonded discs, by tests of a laboratory of discs."""
