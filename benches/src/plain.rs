//! Plain loops: the textbook's formula sample by sample, and the article's scheme in C.

use std::ffi::c_double;

use crate::experiment::Experiment;

/// x and v of the Stokes formula with exp, cos and sin of the system's library for every sample.
pub fn libm(experiment: &Experiment, duration: f64, x: &mut [f64], v: &mut [f64]) {
    let [spring, stokes, ..] = experiment.coefficients();
    let gamma = 0.5 * stokes;
    let omega = (spring - gamma * gamma).sqrt();
    let last = (x.len() - 1) as f64;
    for (i, (x, v)) in x.iter_mut().zip(v).enumerate() {
        let t = duration * i as f64 / last;
        let (decay, cos, sin) = ((-gamma * t).exp(), (omega * t).cos(), (omega * t).sin());
        *x = experiment.position * decay * (cos + gamma / omega * sin);
        *v = -experiment.position * decay * (spring / omega) * sin;
    }
}

#[allow(unsafe_code)]
mod native {
    use super::c_double;

    unsafe extern "C" {
        pub fn scheme_stokes(x: *mut c_double, n: usize, dt: c_double, c: c_double, d: c_double);
        pub fn scheme_coulomb(x: *mut c_double, n: usize, dt: c_double, c: c_double, a: c_double);
        pub fn scheme_newton(x: *mut c_double, n: usize, dt: c_double, c: c_double, k: c_double);
        pub fn scheme_all(
            x: *mut c_double,
            n: usize,
            dt: c_double,
            c: c_double,
            d: c_double,
            a: c_double,
            k: c_double,
        );
    }
}

/// The article's scheme in C, with the loop written for the laws that act.
#[allow(unsafe_code)]
pub fn c_scheme(experiment: &Experiment, dt: f64, x: &mut [f64]) {
    let [spring, stokes, coulomb, newton] = experiment.coefficients();
    let laws = [stokes, coulomb, newton].map(|law| law > 0.0);
    x[0] = experiment.position;
    // From rest sign(0) = 0 leaves the spring alone in the first step.
    x[1] = x[0] - 0.5 * dt * dt * spring * x[0];
    let (start, n) = (x.as_mut_ptr(), x.len());
    // SAFETY: the C loops write x[2] to x[n − 1] and read x[0] to x[n − 2] of this buffer alone.
    unsafe {
        match laws {
            [_, false, false] => native::scheme_stokes(start, n, dt, spring, stokes),
            [false, true, false] => native::scheme_coulomb(start, n, dt, spring, coulomb),
            [false, false, true] => native::scheme_newton(start, n, dt, spring, newton),
            _ => native::scheme_all(start, n, dt, spring, stokes, coulomb, newton),
        }
    }
}
