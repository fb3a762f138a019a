"""Particles where a continuum comes near its strength."""
