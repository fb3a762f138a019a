"""Coarser and finer models of the user's own scene, along each dimension that it has."""
