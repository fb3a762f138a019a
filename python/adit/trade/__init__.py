"""Speed against accuracy: models of one structure from the cheapest to the finest."""
