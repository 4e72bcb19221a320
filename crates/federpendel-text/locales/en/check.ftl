# The article's claims, and what was found of each.
