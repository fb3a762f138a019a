"""States by which ParaView shows runs."""
