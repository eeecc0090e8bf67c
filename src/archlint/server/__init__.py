"""The language server: what archlint finds while somebody types, over the Language Server Protocol."""
