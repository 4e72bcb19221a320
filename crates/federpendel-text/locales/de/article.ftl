# The report on the article: its text.
