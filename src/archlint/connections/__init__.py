"""Who sends what to whom: which ends of one name meet and get through, and whose word counts where several speak."""
