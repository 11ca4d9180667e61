# Fish completion of rocinante and its programs: verbs, subcommands, options and their choices, as --help
# tells them, with what they do; everything else is a file. By hand: source completions/rocinante.fish

# What may stand at the cursor, one a line: the word, a tab, what it does.
function __rocinante_offers
    set -l words (commandline -opc)
    set -l word (commandline -ct)
    set -l before $words[-1]
    set -l command $words[1]
    set -l next 2
    set -l place (math (count $words) + 1)
    set -l listed 's/^  \([a-z][a-z-]*\)  *\([^ ].*\)/\1\t\2/p'
    set -l own --help\t'what it does' --version\t'say the version'
    if string match -qr '(^|/)rocinante$' -- $command
        if test $place = 2
            $command --help 2>/dev/null | sed -n $listed
            printf '%s\n' $own
            return
        end
        set command $command $words[2]
        set next 3
    end
    set -l help ($command --help 2>/dev/null)
    or return 0
    set -l subcommands (printf '%s\n' $help | sed -n "/^Subcommands:/,/^\$/$listed")
    if test -n "$subcommands"
        if test $place = $next
            printf '%s\n' $subcommands $own
            return
        end
        set help ($command $words[$next] --help 2>/dev/null)
        or return 0
    end
    if string match -q -- '--*' $before
        set -l choices (printf '%s\n' $help | sed -n "s/^  \(-[a-z],\)\{0,1\}$before \([^ ]*|[^ ]*\).*/\2/p")
        if test -n "$choices"
            string split '|' -- $choices
            return
        end
    end
    if string match -q -- '-*' $word
        printf '%s\n' $help | sed -n 's/^  \(-[a-z],\)\{0,1\}\(--[a-z-]*\)\( [^ ].*[^ ]\)\{0,1\}   *\([^ ].*\)/\2\t\4/p; t
            s/^  \(-[a-z],\)\{0,1\}\(--[a-z-]*\).*/\2/p'
    else
        __fish_complete_path $word
    end
end

for each in rocinante rocinante-{record,spy,play,source,relay,key,log,model,check,render,view,page,serve,golden}
    complete -c $each -f -a '(__rocinante_offers)'
end
