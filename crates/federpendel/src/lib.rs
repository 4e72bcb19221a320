//! The motion of the friction oscillator.
