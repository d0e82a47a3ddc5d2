<?php
// Imports files of Moodle XML with Moodle's own importer and prints what each blank was read as, in JSON.
//
// usage: php moodle.php MOODLE FILE...
//
// MOODLE is a checkout of Moodle. The site around the importer (strings, tags, files, database) stands below; parsing,
// the blanks of Cloze questions and their validation are Moodle's.

error_reporting(E_ALL & ~E_DEPRECATED);
define('MOODLE_INTERNAL', true);
foreach (['MOODLE' => 0, 'HTML' => 1, 'PLAIN' => 2, 'WIKI' => 3, 'MARKDOWN' => 4] as $name => $number) {
    define("FORMAT_$name", $number);
}
define('PARAM_FILE', 'file');
define('DEBUG_DEVELOPER', 32767);
$CFG = (object) ['dirroot' => $argv[1], 'libdir' => "$argv[1]/lib"];
$USER = (object) ['id' => 1];
$problems = [];

class moodle_exception extends Exception {
    public $a;
    public function __construct($code, $module = '', $link = '', $a = null, $debug = null) {
        $this->a = $a;
        parent::__construct("$code " . json_encode($a));
    }
}
class core_tag_tag {
    public static function is_enabled($component, $type) {
        return false;
    }
}
class context_user {
    public $id = 1;
    public static function instance($id) {
        return new self();
    }
}
class question_bank {
    public static function get_qtype($name) {
        return null;
    }
}
class question_type {
}
class file_store {
    public function create_file_from_string($record, $content) {
        global $files;
        $files[] = ['name' => $record['filename'], 'bytes' => strlen($content), 'head' => substr($content, 0, 4)];
    }
}
class qformat_default {
    public $course;
    protected function error($message, $text = '', $name = '') {
        global $problems;
        $problems[] = $message;
    }
    public function clean_question_name($name) {
        return trim($name);
    }
    protected function defaultquestion() {
        return (object) ['penalty' => 0.3333333, 'defaultmark' => 1];
    }
    public function create_default_question_name($text, $default) {
        return $default;
    }
}
function get_string($name, $module = '', $a = null) {
    return "$module/$name " . json_encode($a);
}
function debugging($message, $level = 0) {
    global $problems;
    $problems[] = $message;
}
function get_file_storage() {
    return new file_store();
}
function file_get_unused_draft_itemid() {
    return 1;
}
function unformat_float($text, $strict = false) {
    return is_numeric($text) ? (float) $text : false;
}
function clean_param($text, $type) {
    return $text;
}
function fullclone($thing) {
    return unserialize(serialize($thing));
}

require_once("$argv[1]/lib/xmlize.php");
require_once("$argv[1]/question/format/xml/format.php");
// The question types, without what they take from the site.
foreach (['numerical', 'multianswer'] as $type) {
    $source = file_get_contents("$argv[1]/question/type/$type/questiontype.php");
    $source = preg_replace('/^require_once.*$/m', '', $source);
    eval(preg_replace('/^<\?php/', '', $source));
}

$all = [];
foreach (array_slice($argv, 2) as $path) {
    $files = [];
    $importer = new qformat_xml();
    $read = $importer->readquestions(file($path));
    if (!$read) {
        $problems[] = "$path: nothing is read";
        continue;
    }
    foreach ($read as $question) {
        if ($question->qtype === 'category') {
            $all[] = ['category' => $question->category];
            continue;
        }
        $blanks = [];
        foreach ($question->options->questions as $blank) {
            $blanks[] = [
                'type' => $blank->qtype,
                'answers' => $blank->answer,
                'fractions' => array_values($blank->fraction),
                'tolerances' => array_values($blank->tolerance),
                'feedback' => array_column(array_values($blank->feedback), 'text'),
            ];
        }
        $all[] = ['name' => $question->name, 'blanks' => $blanks, 'files' => $files, 'text' => $question->questiontext];
        $files = [];
    }
}
echo json_encode(['questions' => $all, 'problems' => $problems], JSON_UNESCAPED_UNICODE | JSON_THROW_ON_ERROR), "\n";
exit($problems ? 1 : 0);
