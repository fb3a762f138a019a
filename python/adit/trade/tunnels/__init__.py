"""Models of whole tunnels, from the cheapest to the finest."""
