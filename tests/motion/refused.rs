//! What is wrong with the ground of a scene, or with its record, is said: the field, the value as typed, what is allowed, and the line.

use chattercheck::motion::scene::Scene;

/// What is missing, not used or not allowed is said with its line.
#[test]
fn what_is_wrong_with_a_motion_is_said() {
    let error = |ground: &str| {
        let text = format!("[block]\nradius = 1\nslenderness = 0.2\nrestitution = 0.9\n[ground]\n{ground}\n");
        Scene::parse(&text).unwrap_err().to_string()
    };
    let sine = "amplitude = { g = 1 }\nfrequency = { hz = 1 }";
    for (ground, said) in [
        ("pulse = \"one-sine\"\nfrequency = { hz = 1 }", "needs amplitude"),
        (
            "pulse = \"one-sine\"\namplitude = { g = 1 }\nfrequency = { hz = 1 }\ncenter = { tau = 1 }",
            "line 9: center is not used by one-sine",
        ),
        ("pulse = \"sawtooth\"", "one-sine"),
        ("pulse = \"ricker\"\namplitude = { g = 1 }\nfrequency = { hz = 1 }", "needs center"),
        (
            "pulse = \"ricker\"\namplitude = { g = 1 }\nfrequency = { hz = 1 }\ncenter = { tau = -1 }",
            "line 9: center = { tau = -1 }",
        ),
        ("pulse = \"mavroeidis-papageorgiou\"\namplitude = { g = 1 }\nfrequency = { hz = 1 }", "needs gamma"),
        (
            "pulse = \"mavroeidis-papageorgiou\"\namplitude = { g = 1 }\nfrequency = { hz = 1 }\ngamma = 0",
            "line 9: gamma = 0",
        ),
        (
            "pulse = \"ricker\"\namplitude = { g = 1 }\nfrequency = { hz = 1e4 }\ncenter = { tau = 1e4 }",
            "line 9: center = ",
        ),
        ("record = { units = \"g\" }", "line 6: file is missing in record; allowed is a text in quotes"),
        ("sinusoids = [ { frequency = { hz = 1 } } ]", "line 6: amplitude is missing in sinusoids"),
        ("sinusoids = []", "sinusoids: allowed is"),
        ("frequency = { hz = 1 }", "needs amplitude"),
        (&format!("{sine}\ngamma = 1"), "line 8: gamma is not used by a sinusoid"),
        (&format!("{sine}\nrecord = {{ file = \"x\" }}"), "amplitude is not used by a record"),
        ("record = { file = \"no such file\", units = \"g\" }", "no such file"),
        ("record = { file = \"x\", units = \"furlongs\" }", "units = \"furlongs\""),
        ("pulse = \"one-sine\"\nrecord = { file = \"x\", units = \"g\" }", "not more than one"),
    ] {
        let found = error(ground);
        assert!(found.contains(said), "{ground}: {found}");
    }
    let text = format!("[block]\nwidth = 1\nhalf_height = 2\nrestitution = 0.9\n[ground]\n{sine}\n");
    let found = Scene::parse(&text).unwrap_err().to_string();
    assert!(
        found.contains("line 3: half_height is half of the height") && found.contains("height = 4 beside width"),
        "{found}"
    );
    let found = Scene::parse(&text.replace("half_height = 2\n", "")).unwrap_err().to_string();
    assert!(found.contains("of the whole block") && found.contains("half of them"), "{found}");
    let text = format!("[block]\nradius = 1\nslenderness = 0.2\n[ground]\n{sine}\n");
    let found = Scene::parse(&text).unwrap_err().to_string();
    assert!(found.starts_with("line 1: restitution is missing in [block]; allowed is a number above 0"), "{found}");
    let start = format!(
        "[block]\nradius = 1\nslenderness = 0.2\nrestitution = 0.9\n[ground]\n{sine}\n[start]\nrotation = 1.5\n"
    );
    assert!(Scene::parse(&start).unwrap_err().to_string().contains("line 9: rotation = 1.5"));
}

/// A sample and a step beyond what a motion may have are said as they are typed, with the line of the file or of the scene.
#[test]
fn what_a_motion_can_not_have_is_said_as_typed() {
    let folder = tempfile::tempdir().unwrap();
    let told = |file: &str, given: &str| {
        std::fs::write(folder.path().join("r.txt"), file).unwrap();
        let block = "[block]\nradius = 1\nslenderness = 0.2\nrestitution = 0.9\n";
        let text = format!("{block}[ground]\nrecord = {{ file = \"r.txt\"{given} }}\n");
        Scene::parse_in(&text, folder.path()).unwrap_err().to_string()
    };
    let header = "UNITS OF G\nNPTS= 4, DT= .01 SEC\n";
    let found = told(&format!("{header}.1 .2\n1E+300 .4\n"), "");
    assert!(found.starts_with("line 6: ") && found.contains("r.txt: line 4: the sample 1E+300 (g) is "), "{found}");
    let found = told(&format!("{header}.1 .2\n.3 .4\n"), ", scale = 1e6");
    assert!(found.contains("r.txt: line 4: the sample .3 (g), times 1000000, is "), "{found}");
    for dt in ["{ seconds = 1e-300 }", "{ tau = 1e-300 }", "{ seconds = 2e9 }"] {
        let found = told("UNITS OF G\n.1\n.2\n", &format!(", dt = {dt}"));
        assert!(found.starts_with(&format!("line 6: dt = {dt} is outside the allowed range: 1e-9 to 1e9")), "{found}");
    }
    let found = told("UNITS OF G\nNPTS= 2, DT= 1E-300 SEC\n.1 .2\n", "");
    assert!(found.contains("r.txt: line 2: dt = 1e-300 s is outside the allowed range"), "{found}");
}

/// What a file says is not overruled in silence, and what it does not say is not guessed.
#[test]
fn a_scene_and_its_record_have_to_agree() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/data/scenes");
    let parse = |record: &str| {
        let block = "[block]\nwidth = 0.4\nheight = 2.2\nrestitution = 0.9\n";
        Scene::parse_in(&format!("{block}[ground]\nrecord = {{ {record} }}\n"), folder.as_ref())
    };
    // The units and the step are in the file.
    let of_file = parse("file = \"shaking.AT2\"").unwrap();
    assert_eq!(of_file.ground, parse("file = \"shaking.AT2\", units = \"g\", dt = { seconds = 0.02 }").unwrap().ground);
    for (record, said) in [
        ("units = \"cm/s2\"", "units are g, the scene units = \"cm/s2\""),
        ("dt = { seconds = 0.01 }", "0.01"),
        ("dt = { tau = 0.01 }", "dt = 0.01 tau, and the file says 0.05"),
        ("direction = 0", "line 6: direction = 0 is outside the allowed range: 1, or -1"),
        ("direction = \"north\"", "with scale, direction, time_scale"),
        ("time_scale = 0", "line 6: time_scale = 0"),
        ("column = 2", "column = 2"),
        ("colour = 2", "known are file, units, scale, direction, time_scale, dt, column"),
    ] {
        let found = parse(&format!("file = \"shaking.AT2\", {record}")).unwrap_err().to_string();
        assert!(found.contains(said) && found.lines().count() == 1, "{record}: {found}");
    }
}
