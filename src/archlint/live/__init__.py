"""A workspace that is kept in memory and analysed again after each edit, saved or not."""
