//! x
use federpendel_fit::model::evaluate;
use federpendel_fit::{Jacobian, Parameters, Quantity, Stop};
fn main() {
    let k: f64 = std::env::args().nth(1).unwrap().parse().unwrap();
    let p = Parameters {
        angular_frequency: 6.3,
        damping_rate: 0.06,
        coulomb_acceleration: 0.15,
        newton_rate: k,
        position0: 1.0,
        velocity0: 0.3,
        equilibrium: 0.0,
    };
    let d = 30.0 * std::f64::consts::PI / 6.3;
    let times: Vec<f64> = (0..2000).map(|i| i as f64 * d / 1999.0).collect();
    let mut v = vec![0.0; 2000];
    let mut j = Jacobian::new();
    for _ in 0..20000 {
        evaluate(&p, Stop::Never, &times, Quantity::Position, &mut v, Some(&mut j)).unwrap();
    }
}
