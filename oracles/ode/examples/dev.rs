#![allow(missing_docs, clippy::all, clippy::unwrap_used, clippy::expect_used, clippy::indexing_slicing)]
use contract::*;
use ode::*;
use std::io::Write;
struct Rng(u64);
impl Rng {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E3779B97F4A7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58476D1CE4E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D049BB133111EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
    fn r(&mut self, a: f64, b: f64) -> f64 {
        a + (b - a) * self.next()
    }
}
fn cases(n: usize, wide: bool) -> Vec<Case> {
    let mut r = Rng(7);
    (0..n)
        .map(|_| {
            if wide {
                Case::from_amplitude(1.0 + 1e-4 * (350f64).powf(r.next()), r.r(0.5, 8.0), r.r(0.5, 0.95)).unwrap()
            } else {
                Case::from_amplitude(r.r(1.005, 1.035), r.r(0.5, 8.0), r.r(0.8, 0.95)).unwrap()
            }
        })
        .collect()
}
fn ode(m: &str) -> Ode {
    Ode::new(Equation::Linear, m.parse().unwrap())
}
fn main() {
    let args: Vec<String> = std::env::args().collect();
    match args[1].as_str() {
        "dump" => {
            // n wide
            let mut f = std::fs::File::create("/tmp/dump.csv").unwrap();
            for c in cases(args[2].parse().unwrap(), true) {
                let h = ode("tsit45").with_rtol(1e-12).unwrap().impacts(&c).unwrap();
                write!(f, "{:e},{:e},{:e}", c.epsilon(), c.omega(), c.eta()).unwrap();
                for i in &h.impacts {
                    write!(f, ",{:e}", i.interval).unwrap();
                }
                writeln!(f).unwrap();
            }
        }
        "acc" => {
            // method rtol
            let text = std::fs::read_to_string("/tmp/truth.csv").unwrap();
            let mut o = ode(&args[2]);
            if args.len() > 3 {
                o = o.with_rtol(args[3].parse().unwrap()).unwrap();
            }
            let lim: usize = args.get(4).map(|s| s.parse().unwrap()).unwrap_or(usize::MAX);
            let mut worst = [0f64; 3];
            let mut first = [0f64; 3];
            let mut under = [0f64; 3];
            let mut ratios = vec![vec![]; 3];
            let mut lost = 0;
            let mut inf = 0;
            let mut nunder = 0;
            let mut tot = 0;
            for line in text.lines().take(lim) {
                let v: Vec<f64> = line.split(',').map(|x| x.parse().unwrap()).collect();
                let c = Case::from_epsilon(v[0], v[1], v[2]).unwrap();
                let h = o.history(&c).unwrap();
                if matches!(h.ending, Ending::Lost(_)) {
                    lost += 1;
                    println!("LOST {:?} {:?} {}", c, h.ending, h.impacts.len());
                }
                for (k, (i, t)) in h.impacts.iter().zip(v[3..].chunks(3)).enumerate() {
                    let e =
                        [(i.time - t[0]).abs(), (i.interval / t[1] - 1.0).abs(), (i.velocity.abs() / t[2] - 1.0).abs()];
                    let u = [i.uncertainty.time, i.uncertainty.interval, i.uncertainty.velocity];
                    for j in 0..3 {
                        tot += 1;
                        worst[j] = worst[j].max(if j == 0 { e[j] / t[0] } else { e[j] });
                        if k == 0 {
                            first[j] = first[j].max(e[j])
                        }
                        if u[j].is_infinite() {
                            inf += 1;
                        }
                        under[j] = under[j].max(e[j] / u[j]);
                        if e[j] > u[j] {
                            nunder += 1;
                            if args.len() > 5 {
                                println!("under {} {k} {e:?} {u:?} {c:?}", j);
                            }
                        }
                        ratios[j].push(u[j] / e[j].max(1e-16));
                    }
                }
            }
            for r in &mut ratios {
                r.sort_by(|a, b| a.total_cmp(b));
            }
            println!(
                "{} rtol {:e}: worst rel err time {:.1e} interval {:.1e} velocity {:.1e}; first {:.1e} {:.1e} {:.1e}; worst err/claim {:.3?}; under {nunder}/{tot}; median claim/err {:?}; 99% {:?} lost {lost} inf {inf}",
                o.name(),
                o.rtol(),
                worst[0],
                worst[1],
                worst[2],
                first[0],
                first[1],
                first[2],
                under,
                ratios.iter().map(|r| r[r.len() / 2] as i64).collect::<Vec<_>>(),
                ratios.iter().map(|r| r[r.len() * 99 / 100] as i64).collect::<Vec<_>>()
            );
        }
        "speed" => {
            let mut o = ode(&args[2]);
            if args.len() > 3 {
                o = o.with_rtol(args[3].parse().unwrap()).unwrap();
            }
            let cs = cases(args.get(4).map(|s| s.parse().unwrap()).unwrap_or(300), false);
            let mut best = 0f64;
            let mut n = 0;
            for _ in 0..3 {
                n = 0;
                let t = std::time::Instant::now();
                for c in &cs {
                    n += o.impacts(c).unwrap().impacts.len();
                }
                best = best.max(n as f64 / t.elapsed().as_secs_f64());
            }
            println!("{} {:e}: {n} impacts, {best:.3e} impacts/s", o.name(), o.rtol());
        }
        "lost" => {
            let mut o = ode(&args[2]);
            if args.len() > 4 {
                o = o.with_rtol(args[4].parse().unwrap()).unwrap();
            }
            let mut m = std::collections::BTreeMap::new();
            for c in cases(args[3].parse().unwrap(), false) {
                let h = o.impacts(&c).unwrap();
                *m.entry(format!("{:?}", h.ending)).or_insert(0) += 1;
                if matches!(h.ending, Ending::Lost(_)) && m.len() < 5 {
                    println!("{c:?} {}", h.impacts.len());
                }
            }
            println!("{} {:?}", o.name(), m);
        }
        _ => {
            // one a omega eta impacts method rtol [naive]
            let g = |k: usize| args[k].parse::<f64>().unwrap();
            let c = Case::from_amplitude(g(2), g(3), g(4)).unwrap().with_max_impacts(g(5) as usize).unwrap();
            let mut o = ode(&args[6]);
            if args.len() > 7 {
                o = o.with_rtol(g(7)).unwrap();
            }
            if args.len() > 8 {
                o = o.with_flights(Flights::Naive);
            }
            let h = o.history(&c).unwrap();
            for (k, i) in h.impacts.iter().enumerate() {
                if k < 5 || k % 20 == 0 || k + 3 > h.impacts.len() {
                    println!("{k} {:?}", i);
                }
            }
            println!("{:?} {}", h.ending, h.impacts.len());
        }
    }
}
