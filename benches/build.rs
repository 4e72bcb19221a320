//! Compiles the plain C loop as a C programmer would: `-O2`, nothing else.

fn main() {
    println!("cargo:rerun-if-changed=native/scheme.c");
    cc::Build::new().file("native/scheme.c").opt_level(2).warnings(true).compile("plain_scheme");
}
