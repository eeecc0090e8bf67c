"""How each connection is used, and whether a topic, a service or an action fits that."""
