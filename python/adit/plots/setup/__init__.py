"""Pictures of a model before it runs: materials, supports, boundaries, loads, probes."""
