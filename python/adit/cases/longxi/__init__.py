"""The Longxi tunnel: along its axis, and its elastic section."""
