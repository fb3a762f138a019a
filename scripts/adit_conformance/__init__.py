"""The checks of scripts/conformance, in the order of its table."""
from adit_conformance import conversation, physics, states, statics

CHECKS = (*conversation.CHECKS, *physics.CHECKS, *statics.CHECKS, *states.CHECKS)
