"""Linings of tunnels beside closed forms."""
