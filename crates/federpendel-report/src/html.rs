//! A [`Document`](crate::Document) as one HTML page that needs nothing else.
