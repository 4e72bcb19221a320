/* The article's difference scheme as a plain loop over an array: x[0] and x[1] are given, the
   quotients divided by the mass too. One loop for each of the article's laws and one for all. */

#include <stddef.h>

static double sign(double q) { return (q > 0.0) - (q < 0.0); }

/* (51): spring c = C/m, Stokes friction d = D/m */
void scheme_stokes(double *x, size_t n, double dt, double c, double d)
{
    for (size_t i = 1; i + 1 < n; i++) {
        double q = (x[i] - x[i - 1]) / dt;
        x[i + 1] = 2 * x[i] - x[i - 1] - dt * dt * (c * x[i] + d * q);
    }
}

/* (59): Coulomb friction a = mu F_N/m */
void scheme_coulomb(double *x, size_t n, double dt, double c, double a)
{
    for (size_t i = 1; i + 1 < n; i++) {
        double q = (x[i] - x[i - 1]) / dt;
        x[i + 1] = 2 * x[i] - x[i - 1] - dt * dt * (c * x[i] + sign(q) * a);
    }
}

/* (85): Newton friction k = rho c_w A/(2 m) */
void scheme_newton(double *x, size_t n, double dt, double c, double k)
{
    for (size_t i = 1; i + 1 < n; i++) {
        double q = (x[i] - x[i - 1]) / dt;
        x[i + 1] = 2 * x[i] - x[i - 1] - dt * dt * (c * x[i] + sign(q) * k * q * q);
    }
}

/* the sum of the terms */
void scheme_all(double *x, size_t n, double dt, double c, double d, double a, double k)
{
    for (size_t i = 1; i + 1 < n; i++) {
        double q = (x[i] - x[i - 1]) / dt;
        x[i + 1] = 2 * x[i] - x[i - 1]
                 - dt * dt * (c * x[i] + d * q + sign(q) * (a + k * q * q));
    }
}
