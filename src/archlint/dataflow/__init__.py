"""How data goes through a system: from callback to callback, and what depends on it."""
