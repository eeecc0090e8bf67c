"""When callbacks run and how long, what they wait for, and which waits never end."""
