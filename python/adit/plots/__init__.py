"""Pictures of runs, and of models before they run."""
