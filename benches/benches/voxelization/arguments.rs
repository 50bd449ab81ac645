//! Which rows and columns of the table.

/// What may be asked for.
pub const CHOICES: &str = "\
arguments, each a comma-separated list; all unless given
  --scenes         triangle, sponza, bunny, dragon, hairball; asian for one of 7 million triangles
  --resolutions    numbers from 8 to 512
  --methods        triangle, fragment, hybrid, balanced
  --separability   thin, conservative
  --attributes     no, yes
  --repeat N       how many times each is timed
  --cutoff         also search the cutoff that makes hybrid fastest";

/// The table's extent.
#[derive(Debug)]
pub struct Arguments {
    pub scenes: Vec<String>,
    pub resolutions: Vec<u32>,
    pub methods: Vec<String>,
    pub separabilities: Vec<String>,
    pub attributes: Vec<bool>,
    pub repeat: usize,
    pub search: bool,
}

impl Arguments {
    /// Reads the command line.
    pub fn parse(list: impl Iterator<Item = String>) -> Result<Arguments, String> {
        let words = |list: &[&str]| list.iter().map(|word| (*word).to_owned()).collect::<Vec<_>>();
        let mut arguments = Arguments {
            scenes: words(&["triangle", "sponza", "bunny", "dragon", "hairball"]),
            resolutions: vec![128, 256, 512],
            methods: words(&METHODS),
            separabilities: words(&SEPARABILITIES),
            attributes: vec![false, true],
            repeat: 5,
            search: false,
        };
        let mut list = list.flat_map(|argument| match argument.split_once('=') {
            Some((name, value)) => vec![name.to_owned(), value.to_owned()],
            None => vec![argument],
        });
        while let Some(name) = list.next() {
            let mut value = || list.next().ok_or_else(|| format!("`{name}` lacks its value"));
            match name.as_str() {
                // Cargo says so to every benchmark.
                "--bench" => {}
                "--cutoff" => arguments.search = true,
                "--scenes" => arguments.scenes = chosen(&value()?, &crate::scenes::NAMES)?,
                "--methods" => arguments.methods = chosen(&value()?, &METHODS)?,
                "--separability" => arguments.separabilities = chosen(&value()?, &SEPARABILITIES)?,
                "--attributes" => {
                    let chosen = chosen(&value()?, &["no", "yes"])?;
                    arguments.attributes = chosen.iter().map(|word| word == "yes").collect();
                }
                "--resolutions" => {
                    let number = |word: &str| word.parse().map_err(|_| format!("`{word}` is no resolution"));
                    arguments.resolutions = value()?.split(',').map(number).collect::<Result<_, _>>()?;
                }
                "--repeat" => {
                    let count = value()?.parse().ok().filter(|count| *count > 0);
                    arguments.repeat = count.ok_or("`--repeat` takes a number from 1")?;
                }
                other => return Err(format!("unknown argument `{other}`")),
            }
        }
        Ok(arguments)
    }
}

const METHODS: [&str; 4] = ["triangle", "fragment", "hybrid", "balanced"];
const SEPARABILITIES: [&str; 2] = ["thin", "conservative"];

fn chosen(list: &str, known: &[&str]) -> Result<Vec<String>, String> {
    let word = |word: &str| match known.contains(&word) {
        true => Ok(word.to_owned()),
        false => Err(format!("unknown `{word}`: one of {}", known.join(", "))),
    };
    list.split(',').map(word).collect()
}
