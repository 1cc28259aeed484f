//! What may be asked for, and what is called wrong.

use crate::program::{Folder, SCENE};

#[test]
fn both_ways_to_give_a_negative_number_work() {
    let folder = Folder::with_scene();
    let glued = folder.render("--eye=-10,0,5 --look=-1,-0.5,-.2 --up=-0.1,0,1");
    let apart = folder.render("--eye -10,0,5 --look -1,-0.5,-.2 --up -0.1,0,1");
    assert_eq!(glued, apart);
    assert_ne!(glued, folder.render(""));
}

#[test]
fn every_camera_argument_changes_the_picture() {
    let folder = Folder::with_scene();
    let usual = folder.render("");
    assert_eq!(usual, folder.render("--eye 0,-150,50 --look 0,1,0 --up 0,0,1"));
    for argument in ["--eye 1,-150,50", "--look 0,1,-0.01", "--up 0.1,0,1"] {
        assert_ne!(usual, folder.render(argument), "{argument}");
    }
}

#[test]
fn the_length_of_a_direction_means_nothing() {
    let folder = Folder::with_scene();
    let usual = folder.render("");
    for argument in ["--look 0,4,0", "--look 0,1e-300,0", "--look 0,1e70,0", "--up 0,0,16", "--up 0,0,1e-320"]
    {
        assert_eq!(usual, folder.render(argument), "{argument}");
    }
}

#[test]
fn looking_straight_up_or_down_has_a_picture() {
    let folder = Folder::with_scene();
    let down = folder.render("--eye 0,0,200 --look 0,0,-1");
    assert_eq!(down, folder.render("--eye 0,0,200 --look 0,0,-1 --up 0,1,0"));
    folder.render("--look 0,0,1");
}

#[test]
fn values_out_of_range_are_refused_with_the_range() {
    let folder = Folder::with_scene();
    for (argument, told) in [
        ("--size 0", "1..=8192"),
        ("--size 99999", "1..=8192"),
        ("--size 8193", "1..=8192"),
        ("--size=-1", "-1"),
        ("--size 4294967296", "4294967296"),
        ("--size 1.5", "1.5"),
        ("--level 5000", "0..=1000"),
        ("--level 1001", "0..=1000"),
        ("--level=-1", "-1"),
        ("--samples 0", "a square number from 1 to 4096"),
        ("--samples 2", "a square number from 1 to 4096"),
        ("--samples 8", "a square number from 1 to 4096"),
        ("--samples 4095", "a square number from 1 to 4096"),
        ("--samples 4225", "a square number from 1 to 4096"),
        ("--samples 4294836225", "a square number from 1 to 4096"),
        ("--samples 4294967296", "a square number from 1 to 4096"),
        ("--samples 9.0", "a square number from 1 to 4096"),
        ("--samples=-9", "a square number from 1 to 4096"),
        ("--samples=", "a square number from 1 to 4096"),
        ("--threads 0", "1..="),
        ("--threads 1000000", "1..="),
        ("--threads two", "two"),
        ("--precision f16", "f64, f32"),
        ("--eye 1,2", "three numbers"),
        ("--eye 1,2,3,4", "three numbers"),
        ("--eye 1,2,x", "three numbers"),
        ("--eye 1,,3", "three numbers"),
        ("--eye nan,0,0", "-1e70 to 1e70"),
        ("--eye inf,0,0", "-1e70 to 1e70"),
        ("--eye 1e71,0,0", "-1e70 to 1e70"),
        ("--eye=", "three numbers"),
        ("--look 0,0,0", "must not be zero"),
        ("--look=-0,0,0.0", "must not be zero"),
        ("--look 1,1", "three numbers"),
        ("--look nan,nan,nan", "three numbers"),
        ("--up 0,0,0", "must not be zero"),
        ("--up a,b,c", "three numbers"),
    ] {
        let said = folder.run(&format!("render scene.txt -o out.bmp {argument}")).misuse();
        assert!(said.contains(told), "{argument}: {said}");
        let option = argument.split([' ', '=']).next().unwrap();
        assert!(said.contains(option), "{argument}: {said}");
    }
    assert_eq!(folder.names(), ["scene.txt"]);
}

#[test]
fn the_ends_of_the_ranges_are_accepted() {
    let folder = Folder::with_scene();
    for argument in
        ["--size 1", "--level 0", "--level 1000", "--threads 1", "--samples 1", "--size 2 --samples 4096"]
    {
        folder.render(argument);
    }
}

#[test]
fn level_and_size_of_the_command_line_win() {
    let folder = Folder::with_scene();
    folder.put("other.txt", SCENE.replace("3\n32\n", "1\n7\n"));
    folder.run("render other.txt -o other.bmp").quiet();
    assert_eq!(folder.read("other.bmp"), folder.render("--level 1 --size 7"));
    assert_ne!(folder.read("other.bmp"), folder.render("--level 3 --size 7"));
}

#[test]
fn one_sample_is_what_is_taken_unless_more_are_asked_for() {
    let folder = Folder::with_scene();
    let usual = folder.render("");
    assert_eq!(usual, folder.render("--samples 1"));
    let smooth = folder.render("--samples 4");
    assert_ne!(usual, smooth);
    assert_ne!(smooth, folder.render("--samples 9"));
}

#[test]
fn level_0_is_black() {
    let folder = Folder::with_scene();
    assert!(folder.render("--level 0 --samples 9")[54..].iter().all(|&byte| byte == 0));
    assert!(folder.render("--level 0")[54..].iter().all(|&byte| byte == 0));
    assert!(folder.render("--level 1")[54..].iter().any(|&byte| byte != 0));
}

#[test]
fn only_endings_that_can_be_written_are_accepted() {
    let folder = Folder::with_scene();
    for name in ["out.jpg", "out", "out.bmp.txt", "bmp", ".bmp", "out.", "out.gif", "out.tiff", "outbmp"] {
        let said = folder.run(&format!("render scene.txt -o {name}")).misuse();
        let expected = format!("cannot tell the format of {name}: its name must end in .bmp or .png");
        assert!(said.contains(&expected), "{name}: {said}");
    }
    for name in ["out.bmp", "out.png", "OUT.BMP", "Out.Png", "a.b.bmp"] {
        folder.run(&format!("render scene.txt -o {name}")).quiet();
    }
    assert_eq!(folder.names(), ["OUT.BMP", "Out.Png", "a.b.bmp", "out.bmp", "out.png", "scene.txt"]);
    assert_eq!(folder.read("OUT.BMP"), folder.read("out.bmp"));
    assert_eq!(folder.read("Out.Png"), folder.read("out.png"));
}

#[test]
fn texture_files_need_the_texture() {
    let folder = Folder::with_scene();
    for argument in ["--white w.bmp", "--black b.bmp"] {
        let said = folder.run(&format!("render scene.txt -o out.bmp {argument}")).misuse();
        assert!(said.contains("--texture"), "{said}");
    }
}

#[test]
fn what_is_missing_or_unknown_is_called_wrong() {
    let folder = Folder::with_scene();
    for arguments in [
        "render",
        "render scene.txt",
        "render -o out.bmp",
        "render scene.txt -o",
        "render scene.txt other.txt -o out.bmp",
        "render scene.txt -o out.bmp --sise 3",
        "render scene.txt -o out.bmp --size",
        "render scene.txt -o out.bmp -o two.bmp",
        "render scene.txt -o out.bmp --size 1 --size 2",
        "check",
        "check scene.txt other.txt",
        "write",
        "paint scene.txt",
    ] {
        folder.run(arguments).misuse();
    }
    assert_eq!(folder.run("").code, Some(2));
    assert_eq!(folder.names(), ["scene.txt"]);
}

#[test]
fn the_help_shows_an_example() {
    let folder = Folder::empty();
    for arguments in ["--help", "-h", "help", "render --help", "help render"] {
        let said = folder.run(arguments).quiet();
        assert!(
            said.contains("archetrace render scenes/official.txt -o official.bmp"),
            "{arguments}: {said}"
        );
    }
    let said = folder.run("render --help").quiet();
    for option in [
        "--output",
        "--eye",
        "--look",
        "--up",
        "--size",
        "--level",
        "--samples",
        "--texture",
        "--white",
        "--black",
        "--precision",
        "--threads",
        "--stats",
    ] {
        assert!(said.contains(option), "{option}");
    }
    for arguments in ["check --help", "write --help"] {
        assert!(folder.run(arguments).quiet().contains("Usage: archetrace "));
    }
}

#[test]
fn the_version_is_that_of_the_package() {
    let said = Folder::empty().run("--version").quiet();
    assert_eq!(said, format!("archetrace {}\n", env!("CARGO_PKG_VERSION")));
}

#[test]
fn the_picture_and_its_figures_are_two_files() {
    let folder = Folder::with_scene();
    folder.run("render scene.txt -o out.bmp --stats out.bmp").misuse();
    assert_eq!(folder.names(), ["scene.txt"]);
}
