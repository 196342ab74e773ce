"""What is proved to be attracted by an orbit."""
