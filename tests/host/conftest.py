"""Random tests: no time limit for one example on a busy machine, and the failing one is printed to repeat."""

from hypothesis import settings

settings.register_profile("tripoint", deadline=None, print_blob=True)
settings.load_profile("tripoint")
