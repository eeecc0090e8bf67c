"""A picture as plain data: what is drawn, before any format writes it.

``making`` is the way there on one page: parts of the whole system, marks on them, what of it is shown, grouped,
gathered and worded.  Nothing after ``parts`` and ``marks`` knows a system.
"""
