//! Raystep's fast structures beside the best there are: rays per second on three scenes, in interleaved rounds. All of it
//! on one thread, whose own time is measured: what else runs on the machine takes caches, but no time.

mod counts;
mod peers;
mod rays;
mod referee;
mod scenes;
mod threads;

use cpu_time::ThreadTime;
use peers::Peer;
use rays::{Ask, Rays};
use raystep_accel::Random;
use raystep_fast::{Bvh2, Fast, Settings};

struct Options {
    rays: usize,
    rounds: usize,
    scenes: Vec<&'static str>,
    only: Vec<String>,
    /// The kinds of rays; all if there are none.
    kinds: Vec<String>,
    /// Whether builds on one thread and on two are to be timed, and nothing else.
    threads: bool,
}

fn options() -> Options {
    let (only, kinds) = (Vec::new(), Vec::new());
    let mut options = Options { rays: 1 << 20, rounds: 7, scenes: scenes::NAMES.to_vec(), only, kinds, threads: false };
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        let mut value = || words.next().unwrap_or_else(|| usage(&word));
        match word.as_str() {
            "--rays" => options.rays = value().parse().unwrap_or_else(|_| usage("--rays wants a power of four")),
            "--rounds" => options.rounds = value().parse().unwrap_or_else(|_| usage("--rounds wants a number")),
            "--scenes" => {
                let names = value();
                options.scenes =
                    scenes::NAMES.into_iter().filter(|name| names.split(',').any(|own| own == *name)).collect();
            }
            "--only" => options.only = value().split(',').map(str::to_owned).collect(),
            "--kinds" => options.kinds = value().split(',').map(str::to_owned).collect(),
            "--threads" => options.threads = true,
            _ => usage(&word),
        }
    }
    options
}

fn usage(what: &str) -> ! {
    let own = "[--rays N] [--rounds N] [--scenes teapot,million,stadium] [--kinds primary,random,shadow]";
    eprintln!("{what}\nraystep-peers {own} [--only PART,PART] [--threads]");
    std::process::exit(2)
}

/// A peer over a scene, and what it took.
struct Built {
    name: &'static str,
    peer: Box<dyn Peer>,
    build_ms: f64,
    /// Nanoseconds a ray, a row for each kind of rays.
    times: [Vec<f64>; 3],
}

fn main() {
    let options = options();
    if options.threads {
        return threads::race(options.rounds);
    }
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread");
    pool.install(|| {
        for name in &options.scenes {
            scene(name, &options);
        }
    });
}

fn scene(name: &'static str, options: &Options) {
    let stage = scenes::stage(name);
    let exact = Bvh2::build(&stage.mesh, &Settings::default());
    let mut kinds = rays::kinds(&stage, options.rays, |rays| exact.intersect_many(rays)).to_vec();
    kinds.retain(|kind| options.kinds.is_empty() || options.kinds.iter().any(|own| own == kind.name));
    println!(
        "\n{}: {} triangles, {} rays of each kind, {} rounds",
        stage.name,
        stage.mesh.triangles.len(),
        options.rays,
        options.rounds
    );
    let mut built: Vec<Built> = peers::makers()
        .into_iter()
        .filter(|maker| {
            maker.name == "obvhs-bvh2-medium"
                || options.only.is_empty()
                || options.only.iter().any(|part| maker.name.contains(part))
        })
        .map(|maker| {
            let start = ThreadTime::now();
            let peer = (maker.build)(&stage.mesh);
            Built { name: maker.name, peer, build_ms: start.elapsed().as_secs_f64() * 1e3, times: Default::default() }
        })
        .collect();
    check(&stage.mesh, &kinds, &exact, &built);
    let mut random = Random::new(9);
    let mut nearest = vec![None; options.rays];
    let mut any = vec![false; options.rays];
    for round in 0..=options.rounds {
        for (kind, Rays { ask, rays, .. }) in kinds.iter().enumerate() {
            let mut order: Vec<usize> = (0..built.len()).collect();
            for i in (1..order.len()).rev() {
                order.swap(i, random.below(i as u32 + 1) as usize);
            }
            for at in order {
                let start = ThreadTime::now();
                match ask {
                    Ask::Nearest => built[at].peer.nearest(rays, &mut nearest),
                    Ask::Any => built[at].peer.any(rays, &mut any),
                }
                let took = start.elapsed().as_secs_f64() * 1e9 / rays.len() as f64;
                // The first round warms up.
                if round > 0 {
                    built[at].times[kind].push(took);
                }
            }
        }
    }
    print(&built, &kinds);
    counts::print(&built, &kinds);
}

/// Hits before speed: every peer's answers beside the exact ones.
fn check(mesh: &raystep_accel::Mesh, kinds: &[Rays], exact: &Bvh2, built: &[Built]) {
    for Rays { name, ask, rays } in kinds {
        let truth = exact.intersect_many(rays);
        let own = referee::report(mesh, rays, &truth, &truth);
        assert_eq!(own.wrong, 0, "{name}: hits of ours that double precision does not know");
        for Built { name: peer, peer: own, .. } in built {
            let wrong = match ask {
                Ask::Nearest => {
                    let mut found = vec![None; rays.len()];
                    own.nearest(rays, &mut found);
                    if peer.starts_with("fast") {
                        assert!(found == truth, "{peer}, {name}: not the exact answers");
                    }
                    referee::report(mesh, rays, &truth, &found).wrong
                }
                Ask::Any => {
                    let mut found = vec![false; rays.len()];
                    own.any(rays, &mut found);
                    truth.iter().zip(found).filter(|(hit, any)| hit.is_some() != *any).count()
                }
            };
            let share = wrong as f64 / rays.len() as f64;
            assert!(share <= referee::SLIPS, "{peer}, {name}: {wrong} of {} answers are wrong", rays.len());
            if wrong > 0 {
                println!("  {peer}, {name}: {wrong} of {} answers differ from double precision", rays.len());
            }
        }
    }
}

fn median(numbers: &[f64]) -> f64 {
    let mut sorted = numbers.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted[sorted.len() / 2]
}

fn print(built: &[Built], kinds: &[Rays]) {
    print!("{:<24}{:>10}{:>9}", "", "build ms", "MB");
    for kind in kinds {
        print!("{:>11} Mrays/s  ratio (spread)  ", kind.name);
    }
    println!();
    for one in built {
        let megabytes = one.peer.bytes().map_or("-".to_owned(), |bytes| format!("{:.1}", bytes as f64 / 1e6));
        print!("{:<24}{:>10.1}{megabytes:>9}", one.name, one.build_ms);
        for kind in 0..kinds.len() {
            let ratios: Vec<f64> =
                built[0].times[kind].iter().zip(&one.times[kind]).map(|(first, own)| first / own).collect();
            let (low, high) = ratios.iter().fold((f64::MAX, 0.0f64), |(low, high), &own| (low.min(own), high.max(own)));
            let spread = format!("({low:.2}-{high:.2})");
            print!("{:>19.2}  {:>5.2} {spread:<13}  ", 1e3 / median(&one.times[kind]), median(&ratios));
        }
        println!();
    }
}
