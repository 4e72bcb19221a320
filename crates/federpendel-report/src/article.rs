//! The report on the article.
