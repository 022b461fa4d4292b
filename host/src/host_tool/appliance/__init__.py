"""The only place that opens sockets: a Tripoint unit on the network."""
