"""The checks of adit conformance, in the order of its table."""
from adit.conformance import conversation, physics, states, statics

CHECKS = (*conversation.CHECKS, *physics.CHECKS, *statics.CHECKS, *states.CHECKS)
