"""What the studies of cases measure in their runs, and the theory that they are compared with."""
