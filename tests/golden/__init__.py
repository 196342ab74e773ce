"""What the commands answer: recorded once, compared after every change."""
