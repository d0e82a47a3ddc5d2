//! Files that are imported into tables of numbers.

use std::{fs, path::Path};

use dalembert_tests::person::Person;

use super::data_entry::{PARTS, RESPONSE, before, text, words};

fn write(folder: &Path, name: &str, text: &str) -> String {
    let path = folder.join(name);
    fs::write(&path, text).expect("written");
    path.display().to_string()
}

#[test]
fn a_file_is_imported_by_a_key_and_by_its_name_in_the_palette() {
    let folder = tempfile::tempdir().expect("a folder");
    let data = "[Hz]; [(m/s^2)/N]; [(m/s^2)/N]\n10; 0.5; 0.1\n12; 1.5; 2.5\n14; -2; 1.5\n";
    let path = write(folder.path(), "measured.csv", data);
    let mut person = before(Person::at(80, 24).opens(RESPONSE), "accelerance", PARTS);
    let kept = text(&person, PARTS);
    assert!(person.sees().contains("@ imports a file"), "{}", person.sees());
    // A path that leads nowhere stays there to be corrected.
    person.types("@nowhere.csv<enter>");
    assert!(words(&mut person).contains("file nowhere.csv"), "{}", person.sees());
    assert_eq!(text(&person, PARTS), kept);
    person.types(&"<bs>".repeat("nowhere.csv".len())).types(&path).types("<enter>");
    assert_eq!(text(&person, PARTS), kept, "a file is shown before it is taken");
    assert!(person.sees().contains("3 rows"), "{}", person.sees());
    person.types("<enter>");
    assert_eq!(text(&person, PARTS), data);
    assert!(person.model.dialog.is_none(), "{}", person.sees());
    person.types("z");
    assert_eq!(text(&person, PARTS), kept);
    // From anywhere in the problem, where there is one table alone.
    person.types("<home>:import a file<enter>").types(&path).types("<enter><enter>");
    assert_eq!(text(&person, PARTS), data);
    // Not a problem file: what to do with it is said.
    person.types("o").types(&path).types("<enter>");
    let seen = words(&mut person);
    assert!(seen.contains("measured.csv holds data, not a problem"), "{}", person.sees());
    assert!(seen.contains("import the file there with @"), "{}", person.sees());
}

#[test]
fn broken_data_files_are_reported_by_what_is_in_them() {
    let folder = tempfile::tempdir().expect("a folder");
    let two = write(folder.path(), "two.csv", &"1.5,2.5\n".repeat(40));
    let five = write(folder.path(), "five.csv", "1,2,3,4,5\n");
    let one = write(folder.path(), "one.txt", "1\n2\n");
    let empty = write(folder.path(), "empty.csv", "\n");
    let mut person = before(Person::at(60, 30).opens(RESPONSE), "accelerance", PARTS);
    for (path, reported) in [
        (&two, "line 1 and 39 more: 2 columns separated by commas instead of 3: Frequency; Real"),
        (&five, "the rows have 5 columns and the table 3"),
        (&one, "line 1 and 1 more: one column instead of 3: Frequency;"),
    ] {
        person.pastes(&format!("@{path}"));
        assert!(words(&mut person).contains(reported), "{reported}: {}", person.sees());
        // A dialog with the columns of the file, or a sentence.
        if person.model.dialog.is_some() {
            person.types("<esc>");
        }
    }
    let kept = text(&person, PARTS);
    person.pastes(&format!("@{empty}"));
    assert!(words(&mut person).contains("empty.csv: the file is empty"), "{}", person.sees());
    let large = folder.path().join("large.csv");
    fs::File::create(&large).and_then(|file| file.set_len(300 << 20)).expect("a hole of 300 MiB");
    person.pastes(&format!("@{}", large.display()));
    let seen = words(&mut person);
    assert!(seen.contains("is too large for a table (limit 256 MiB)"), "{}", person.sees());
    assert_eq!(text(&person, PARTS), kept);
}

#[test]
fn rows_and_units_of_a_table_are_seen_and_what_is_assumed_is_named() {
    let folder = tempfile::tempdir().expect("a folder");
    let bare = write(folder.path(), "bare.csv", "10;0,512;0,125\n12;1,503;2,501\n14;-2,001;1,500\n");
    let named = write(
        folder.path(),
        "named.csv",
        "f [Hz]; Re [1/kg]; Im [1/kg]\n10; 0.5; 0.1\n12; 1.5; 2.5\n\n14; -2; 1.5\n",
    );
    let mut person = before(Person::at(140, 40).opens(RESPONSE), "accelerance", PARTS);
    for _ in 0..2 {
        person.pastes(&format!("@{bare}"));
        person.types("<enter>");
        let seen = words(&mut person);
        let units = "3 rows · Hz, 1/kg, 1/kg assumed";
        assert_eq!(seen.matches(units).count(), 2, "row and message: {}", person.sees());
        assert!(seen.contains("assumed: no unit in the heading"), "{}", person.sees());
        person.pastes(&format!("@{named}"));
        person.types("<enter>");
        let seen = words(&mut person);
        assert_eq!(seen.matches("3 rows · Hz, 1/kg, 1/kg").count(), 2, "{}", person.sees());
        assert!(!seen.contains("assumed"), "{}", person.sees());
    }
    person.types("u");
    assert!(words(&mut person).contains("the heading of the table gives its units"), "{}", person.sees());
}

#[test]
fn a_file_is_seen_with_its_columns_and_units_before_it_is_taken() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = write(
        folder.path(),
        "run.csv",
        "Model;DS1\nRate;500\nf [Hz];n;Re;Im [1/kg]\n10;1;0,5;0,125\n12;2;1,5;2,5\n14;3;-2,0;1,5\n",
    );
    for (language, assumed, total) in [("en", "assumed", "3 rows"), ("pt", "por suposição", "3 linhas")] {
        let person = if language == "en" { Person::at(80, 24) } else { Person::in_portuguese(80, 24) };
        let mut person = before(person.opens(RESPONSE), "accelerance", PARTS);
        let kept = text(&person, PARTS);
        person.types("@").types(&path).types("<enter>");
        // Four columns for a table of three: they are shown with their numbers.
        let seen = person.sees();
        for words in ["f [Hz]", "Im [1/kg]", "0,125"] {
            assert!(seen.contains(words), "{words}: {seen}");
        }
        person.types("#1,3,4<enter>");
        let seen = person.sees();
        for words in ["Hz", "1/kg", assumed, total] {
            assert!(seen.contains(words), "{words}: {seen}");
        }
        assert_eq!(text(&person, PARTS), kept);
        // Another part is read anew, and only what is shown is taken.
        person.types("<bs><bs><enter>");
        assert_eq!(text(&person, PARTS), kept);
        person.types(",4<enter><enter>");
        assert!(person.model.dialog.is_none(), "{}", person.sees());
        assert!(
            text(&person, PARTS).ends_with("10\t0,5\t0,125\n12\t1,5\t2,5\n14\t-2,0\t1,5\n"),
            "{}",
            text(&person, PARTS)
        );
    }
}

#[test]
fn a_path_typed_behind_the_import_key_is_never_keys_of_the_form() {
    let mut person = Person::at(80, 24).opens("vibration/rotating-unbalance");
    let before = person.model.bench.as_ref().map(|bench| bench.problem.inputs.form.draft.clone());
    let why = "this problem has no table of numbers";
    person.types("@");
    assert!(words(&mut person).contains(why), "{}", person.sees());
    person.types("v.toml");
    assert!(person.sees().contains("@v.toml"), "{}", person.sees());
    person.types("<enter>");
    assert!(words(&mut person).contains(why), "{}", person.sees());
    person.types("<esc>");
    assert!(person.model.dialog.is_none());
    let after = person.model.bench.as_ref().map(|bench| bench.problem.inputs.form.draft.clone());
    assert_eq!(before, after);
}
