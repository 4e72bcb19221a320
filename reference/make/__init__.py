"""Reference problems of a rubbed spring pendulum, computed twice at high precision."""
