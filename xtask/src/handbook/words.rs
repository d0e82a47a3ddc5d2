//! Words of the pages themselves, in both languages; those of analyses come from the program.

use serde_json::Value as Json;

/// Words of a language.
#[derive(Debug)]
pub(super) struct Words {
    /// Language, as the program names it.
    pub(super) language: &'static str,
    /// Name of the language in itself.
    pub(super) name: &'static str,
    /// The documents of the project are written in it.
    pub(super) has_documents: bool,
    pub(super) handbook: &'static str,
    pub(super) about: &'static str,
    pub(super) guide: &'static str,
    pub(super) problem_files: &'static str,
    pub(super) units: &'static str,
    pub(super) glossary: &'static str,
    pub(super) theory: &'static str,
    pub(super) derivation: &'static str,
    pub(super) search: &'static str,
    pub(super) nothing: &'static str,
    pub(super) inputs: &'static str,
    pub(super) input: &'static str,
    pub(super) symbol: &'static str,
    pub(super) meaning: &'static str,
    pub(super) values: &'static str,
    pub(super) as_in: &'static str,
    pub(super) answers: &'static str,
    pub(super) answer: &'static str,
    pub(super) unit: &'static str,
    pub(super) cases: &'static str,
    pub(super) case: &'static str,
    pub(super) worked: &'static str,
    pub(super) file: &'static str,
    pub(super) file_text: &'static str,
    pub(super) printed: &'static str,
    pub(super) computed: &'static str,
    pub(super) verdict: &'static str,
    pub(super) agreed: &'static str,
    pub(super) disputed: &'static str,
    pub(super) differing: &'static str,
    pub(super) comparisons: &'static str,
    pub(super) questions: &'static str,
    pub(super) formula: &'static str,
    pub(super) sources: &'static str,
    pub(super) keywords: &'static str,
    pub(super) previous: &'static str,
    pub(super) next: &'static str,
    /// Words of the page that solves, each by the name that its script has for it.
    pub(super) solver: &'static [(&'static str, &'static str)],
}

impl Words {
    /// Every language.
    pub(super) const ALL: [&'static Words; 2] = [&ENGLISH, &PORTUGUESE];

    /// The words of the page that solves, for its script.
    pub(super) fn of_solver(&self) -> Json {
        let own = [("inputs", self.inputs), ("answers", self.answers), ("file", self.file)];
        own.iter().chain(self.solver).map(|(name, words)| ((*name).to_owned(), Json::from(*words))).collect()
    }

    /// The word for a verdict of the program.
    pub(super) fn verdict_of(&self, verdict: &str) -> &'static str {
        match verdict {
            "agreed" => self.agreed,
            "disputed" => self.disputed,
            _ => self.differing,
        }
    }
}

const ENGLISH: Words = Words {
    language: "en",
    name: "English",
    has_documents: true,
    handbook: "Handbook of d’Alembert",
    about: "Every analysis of the workbench with its inputs, answers and formulas, the published cases that it is \
            compared with, and the worked solution of each.",
    guide: "Guide",
    problem_files: "Problem files",
    units: "Units",
    glossary: "Glossary",
    theory: "Theory",
    derivation: "derivation",
    search: "Search titles, keywords, books, symbols",
    nothing: "Nothing is found.",
    inputs: "Inputs",
    input: "Input",
    symbol: "Symbol",
    meaning: "Meaning",
    values: "Values",
    as_in: "as in",
    answers: "Answers",
    answer: "Answer",
    unit: "Unit",
    cases: "Cases",
    case: "Case",
    worked: "Worked solution",
    file: "Problem file",
    file_text: "Text of the problem file",
    printed: "Reference",
    computed: "Computed",
    verdict: "Verdict",
    agreed: "agreed",
    disputed: "disputed",
    differing: "differing",
    comparisons: "Comparison with the reference values",
    questions: "Usual questions",
    formula: "Formula",
    sources: "Sources",
    keywords: "Keywords",
    previous: "Previous case",
    next: "Next case",
    solver: &[
        ("solve", "Edit and solve here"),
        ("size", "loads the program once, 4 MB"),
        ("loading", "Loading the program …"),
        (
            "missing",
            "solver.js, in the folder above that of the language, cannot be read: copy the whole handbook",
        ),
        ("solving", "Solving …"),
        ("stop", "Stop"),
        ("stopped", "stopped"),
        ("fault", "The program stopped unexpectedly; the problem is unchanged"),
        ("common", "Definitions, questions, given answers, configurations"),
        ("add", "Add a row"),
        ("takeOut", "Remove"),
        ("putIn", "Include"),
        ("leaveOut", "Leave out"),
        ("wrong", "No answers while an input is wrong; the solution below is for the previous inputs."),
        ("ownAnswers", "Check your own answers"),
        ("checking", "Type what you found, with its unit; what is left empty is not checked."),
        ("check", "Check"),
        ("searching", "Searching for the cause …"),
        ("again", "Back to the published inputs"),
    ],
};

const PORTUGUESE: Words = Words {
    language: "pt-BR",
    name: "Português",
    has_documents: false,
    handbook: "Manual do d’Alembert",
    about: "Todas as análises do programa com suas entradas, respostas e fórmulas, os casos publicados com os quais são \
            comparadas e a solução desenvolvida de cada um.",
    guide: "Guia (em inglês)",
    problem_files: "Arquivos de problema (em inglês)",
    units: "Unidades (em inglês)",
    glossary: "Glossário",
    theory: "Teoria (em inglês)",
    derivation: "dedução",
    search: "Procurar títulos, palavras-chave, livros, símbolos",
    nothing: "Nada foi encontrado.",
    inputs: "Entradas",
    input: "Entrada",
    symbol: "Símbolo",
    meaning: "Significado",
    values: "Valores",
    as_in: "como em",
    answers: "Respostas",
    answer: "Resposta",
    unit: "Unidade",
    cases: "Casos",
    case: "Caso",
    worked: "Solução desenvolvida",
    file: "Arquivo de problema",
    file_text: "Texto do arquivo de problema",
    printed: "Referência",
    computed: "Calculado",
    verdict: "Veredito",
    agreed: "concorda",
    disputed: "contestado",
    differing: "difere",
    comparisons: "Comparação com os valores de referência",
    questions: "Perguntas usuais",
    formula: "Fórmula",
    sources: "Fontes",
    keywords: "Palavras-chave",
    previous: "Caso anterior",
    next: "Próximo caso",
    solver: &[
        ("solve", "Editar e resolver aqui"),
        ("size", "carrega o programa uma vez, 4 MB"),
        ("loading", "Carregando o programa …"),
        ("missing", "solver.js, na pasta acima da do idioma, não pode ser lido: copie o manual inteiro"),
        ("solving", "Resolvendo …"),
        ("stop", "Parar"),
        ("stopped", "interrompido"),
        ("fault", "O programa parou inesperadamente; o problema não mudou"),
        ("common", "Definições, perguntas, respostas dadas, configurações"),
        ("add", "Acrescentar uma linha"),
        ("takeOut", "Retirar"),
        ("putIn", "Incluir"),
        ("leaveOut", "Deixar fora"),
        (
            "wrong",
            "Não há respostas enquanto uma entrada estiver errada; a solução abaixo é a das entradas anteriores.",
        ),
        ("ownAnswers", "Conferir as suas respostas"),
        ("checking", "Escreva o que encontrou, com a unidade; o que fica vazio não é conferido."),
        ("check", "Conferir"),
        ("searching", "Procurando a causa …"),
        ("again", "Voltar aos dados publicados"),
    ],
};
