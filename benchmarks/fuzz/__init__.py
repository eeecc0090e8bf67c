"""Made-up workspaces, plausible ones with odd parts, and what must be true of every run over them."""
