"""Objects of Python's own: what their methods do, and how members of enums and objects of data classes are made."""
