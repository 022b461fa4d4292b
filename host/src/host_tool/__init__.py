"""host-tool: the engineer's side of a Tripoint unit."""

__version__ = "0.1.0"
