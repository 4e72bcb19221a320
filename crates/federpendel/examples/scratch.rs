use federpendel::*;
use std::time::Instant;
fn main() {
    let cases = [(0.0,0.0,0.1),(0.,0.,1.0),(0.02,0.,0.1),(0.02,0.05,0.),(0.,0.05,0.1),(0.02,0.05,0.1)];
    for (f,g,k) in cases {
        let fr = Friction { stokes: Some(Stokes::new(2.0*g).unwrap()), coulomb: if f>0.0 {Some(Coulomb::new(f,f,NormalForce::Given(1.0)).unwrap())} else {None}, newton: Some(Newton::new(k).unwrap()) };
        let o = Oscillator::new(1.0,1.0,fr).unwrap();
        let m = Motion::new(o, State::new(1.0,0.0).unwrap()).unwrap();
        println!("{f} {g} {k} {:?}", m.kind());
        let tp: Vec<_> = m.turning_points().take(6).collect();
        for t in &tp { print!("({:.15} {:.16}) ", t.time, t.position); }
        println!("\n  {:?}", m.outcome());
        for t in [1.0, 10.0, 20.0] { println!("   {:?}", m.at(t).unwrap()); }
    }
    let fr = Friction { stokes: Some(Stokes::new(0.05).unwrap()), coulomb: Some(Coulomb::new(0.005,0.005,NormalForce::Weight(9.81)).unwrap()), newton: Some(Newton::new(0.047).unwrap()) };
    let m = Motion::new(Oscillator::new(0.5,20.0,fr).unwrap(), State::new(0.1,0.0).unwrap()).unwrap();
    println!("{:?} want 26 swings, rest at 0.289166337655 mm, t = 12.9156488513554", m.outcome());
    let times = even_times(20.0, 10000).unwrap();
    let (mut x, mut v) = (vec![0.0;10000], vec![0.0;10000]);
    for (name, fr) in [("all", fr), ("newton", Newton::new(0.235).unwrap().into()), ("coulomb", Coulomb::new(0.02,0.02,NormalForce::Weight(9.81)).unwrap().into()), ("stokes", Stokes::new(0.2).unwrap().into())] {
        let o = Oscillator::new(0.5,20.0,fr).unwrap();
        for _ in 0..3 {
        let t0 = Instant::now();
        for _ in 0..100 { let m = Motion::new(o, State::new(0.1,0.0).unwrap()).unwrap(); m.sample(&times,&mut x,&mut v).unwrap(); }
        print!("{name} sample {:?} ", t0.elapsed()/100);
        let t0 = Instant::now();
        for _ in 0..100 { let m = Motion::new(o, State::new(0.1,0.0).unwrap()).unwrap(); std::hint::black_box(m.turning_points().take_while(|p| p.time<20.0).count()); }
        println!("turning {:?}", t0.elapsed()/100);
        }
    }
    // weak newton 1e6 periods
    let o = Oscillator::new(1.0,1.0,Newton::new(1e-6).unwrap()).unwrap();
    let m = Motion::new(o, State::new(1.0,0.0).unwrap()).unwrap();
    let t0 = Instant::now();
    println!("{:?} {:?}", m.at(2e6*std::f64::consts::PI), t0.elapsed());
}
