"""Speech: how people interrupt, correct and take back what they say, and what they say in passing."""
