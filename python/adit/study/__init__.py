"""Many runs of one scene, and what follows from them: `adit study`."""
