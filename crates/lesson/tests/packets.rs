//! Packets: which rays they have, what is said and asked of them, and what is said of wrong ones.

use raystep_accel::{Accel, Fill, List, Observer};
use raystep_lesson::{Facts, Library, Medium, Tape, check};

const SLIDE: &str = include_str!("good_packet.md");

const LISTING: &str = "walk(packet)
  enter it     | packet.enter : {{node}} {{lanes lane}}
  cut          | plane : {{t}}
  on           | packet.split
  push         | packet.push
  pop          | packet.pop : {{waited}}
  test         | packet.test test
  return       | packet.end
";

fn library(slide: &str) -> Library {
    let listing = ("listings/together.txt".to_owned(), LISTING.to_owned());
    Library::from_files([("08-fast/59-together.md".to_owned(), slide.to_owned()), listing])
}

fn problems(slide: &str) -> String {
    check(&library(slide), &|_, _| Vec::new()).iter().map(|problem| format!("  {problem}\n")).collect()
}

#[test]
fn packets_walk_together_and_each_ray_finds_what_it_finds_alone() {
    assert_eq!(problems(SLIDE), "");
    let library = library(SLIDE);
    let slide = &library.slides[0];
    let stage = &slide.stages[0];
    let built = stage.build(slide.plays).unwrap();
    let mut told = String::new();
    for named in &stage.rays {
        let play = built.play(Some(named.ray), &slide.beats).unwrap();
        let Tape::Packet(packet) = &play.tape else { panic!("a packet") };
        assert_eq!(packet.rays.len(), 1 + named.others.len());
        let mut fill = Fill::default();
        for event in &packet.events {
            fill.on(*event);
        }
        for (lane, ray) in packet.rays.iter().enumerate() {
            assert_eq!(packet.found[lane], List.intersect(&play.scene.prims, ray, &mut ()), "lane {lane}");
            assert_eq!(packet.found[lane], packet.alone[lane].hit, "lane {lane}");
        }
        let alone: u64 = packet.costs.iter().map(|cost| cost.node_visits).sum();
        told += &format!("{}: {} rays, {fill:?}, alone {alone}\n", named.name, packet.rays.len());
        for (beat, step) in slide.beats.iter().zip(&play.beats) {
            let Some(facts) = step.and_then(|step| Facts::at(&play, step)) else { continue };
            told += &format!("  {step:?} {}\n", beat.text(&facts, Medium::Paper));
            for fact in ["lanes", "count.packet.enter", "alone.count.enter", "alone.count.test"] {
                told += &format!("     {fact} {:?}\n", facts.field(fact));
            }
            for choice in beat.ask.iter().flat_map(|ask| ask.choices(&play, step.unwrap())) {
                told += &format!("     {:?}{}\n", choice.value, if choice.right { ", right" } else { "" });
            }
        }
    }
    insta::assert_snapshot!(told);
}

#[test]
fn a_ray_by_hand_takes_the_packet_with_it() {
    let library = library(SLIDE);
    let slide = &library.slides[0];
    let stage = &slide.stages[0];
    let built = stage.build(slide.plays).unwrap();
    let own = raystep_accel::Ray::new(glam::Vec3::new(4.0, 5.0, 0.0), glam::Vec3::new(0.0, -1.0, 0.0)).unwrap();
    let play = built.play(Some(own), &slide.beats).unwrap();
    let Tape::Packet(packet) = &play.tape else { panic!("a packet") };
    assert_eq!((packet.rays.len(), packet.rays[0]), (4, own));
    // A fan stays a fan, and as wide as it was.
    let first = &stage.rays[0];
    assert!(packet.rays.iter().all(|ray| (ray.o - own.o).length() < 1e-5));
    let wide = |rays: [glam::Vec3; 2]| rays[0].normalize().dot(rays[1].normalize());
    let (before, now) = (wide([first.ray.d, first.others[2].d]), wide([packet.rays[0].d, packet.rays[3].d]));
    assert!((before - now).abs() < 1e-5, "{before} {now}");
}

#[test]
fn wrong_packets_are_told_what_is_wrong() {
    let mistakes = [
        ("rays instead", "packets = [", "rays = ["),
        ("none", "packets = [", "packages = ["),
        ("no list", "packets = [", "packets = 4 #"),
        (
            "one packet",
            "  { name = \"each its own\", from = [[2.2, -0.9], [6.5, -0.9], [6.75, -0.9]], direction = [0, 1], lanes = 3, t = [0, 50] },\n",
            "",
        ),
        ("too many rays", "lanes = 3", "lanes = 17"),
        ("half a ray", "lanes = 3", "lanes = 2.5"),
        ("points that do not fit", "lanes = 3", "lanes = 4"),
        ("no point", "from = [-0.6, 1.7]", "from = [-0.6]"),
        ("no direction", "direction = [0, 1]", "direction = [0, 0]"),
        ("neither", ", direction = [0, 1]", ""),
        ("nowhere to go", "towards = [[9, 1.3], [9, 4.6]]", "towards = [-0.6, 1.7]"),
        ("misspelt", "lanes = 3", "lane = 3"),
        ("the same name", "name = \"each its own\"", "name = \"a fan\""),
        (
            "the same first ray",
            "from = [[2.2, -0.9], [6.5, -0.9], [6.75, -0.9]], direction = [0, 1], lanes = 3, t = [0, 50]",
            "from = [-0.6, 1.7], towards = [[9, 1.3], [9, 2.6]]",
        ),
        ("a structure that packets do not walk", "kind = \"kd\", max_depth = 6, min_objects = 2", "kind = \"grid\""),
        ("a promise that is not kept", "promise = [\"packet.split.both\"", "promise = [\"packet.split.none\""),
        ("unknown event", "{at=packet.end}", "{at=packet.stop}"),
        ("unknown field", "{{lanes ray}} of", "{{lane ray}} of"),
        ("of rays alone something else", "{{alone.count.enter}}", "{{alone.enter.t_near}}"),
        ("of rays alone an unknown event", "{{alone.count.enter}}", "{{alone.count.entre}}"),
        ("an answer that is none", "> - rest:", "> - nobody:"),
        ("a packet that is not there", "{at=packet.end}", "{at=packet.end ray=\"a fna\"}"),
    ];
    let mut table = String::new();
    for (what, from, to) in mistakes {
        assert!(SLIDE.contains(from), "the good slide has no {from:?}");
        let found = problems(&SLIDE.replacen(from, to, 1));
        assert!(!found.is_empty(), "{what} goes unnoticed");
        table += &format!("{what}\n{found}");
    }
    insta::assert_snapshot!(table);
}
